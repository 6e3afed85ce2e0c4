package steward.machines.serve;

import steward.contest.Contest;
import steward.files.InputException;
import steward.files.JarFolder;
import steward.league.LeagueSettings;
import steward.machines.check.GameJar;
import steward.machines.check.MachineSpeed;
import steward.machines.check.RulesFingerprint;
import steward.machines.wire.LeagueWord;
import steward.machines.wire.WorkerWord;

/** Conditions under which workers play for a league: the same rules, the same jar of the game, and time limits. */
final class LeagueTerms {

    private static final int LONGEST_TEXT = 200;

    private final Contest contest;
    private final LeagueSettings settings;
    private final String version;
    private final String rules;
    private final String jar;
    /** Speed of this machine, to scale time limits; 0 if they are not scaled. */
    private final int speed;

    LeagueTerms(Contest contest, LeagueSettings settings, RemoteGames.Service service) {
        this.contest = contest;
        this.settings = settings;
        version = service.version();
        rules = RulesFingerprint.of(contest.setup());
        jar = JarFolder.digestOf(contest.setup());
        speed = service.scaled() ? MachineSpeed.measure() : 0;
    }

    /** Returns why a worker cannot play, by what it says of itself; {@code null} if it can. */
    String refusal(WorkerState state, WorkerWord.Hello hello) {
        String ours = contest.setup().plan().law().key();
        String theirs = contest.setup().plan().law().keyAmong(hello.bits());
        return !theirs.equals(ours) ? state.apart(shown(hello.version()), shown(theirs), version, ours)
            : contest.setup().isGuest() && !hello.guests() ? state.withoutGuests() : null;
    }

    /** Notes in a worker's state on which terms it plays. */
    void note(WorkerState state, WorkerWord.Hello hello) {
        state.version = shown(hello.version());
        state.scale = speed == 0 ? 1 : MachineSpeed.scale(speed, hello.speed());
        state.machine = shown(hello.machine()) + (speed == 0 ? "" : ", time limits times " + state.scale);
    }

    LeagueWord.Welcome welcome(WorkerState state) {
        return new LeagueWord.Welcome(version, rules, jar, settings.factor() * state.scale, settings.basis(),
            settings.hiccups(), settings.hold(), contest.setup().scene().json());
    }

    /**
     * Describes the difference that a worker has found.
     *
     * @throws InputException if it speaks of a jar, and the game has none
     */
    String difference(WorkerState state, WorkerWord.Differs differs) {
        if (jar == null && differs.jar() != null) {
            throw new InputException("found a word about a jar, expected none: the game has no jar");
        }
        return differs.jar() == null ? state.apart(state.version, shown(differs.rules()), version, rules)
            : "worker " + state.name + ": " + GameJar.missing(shown(differs.jar()), jar);
    }

    /** Returns a text of a worker as it may be printed: without control characters, and not too long. */
    static String shown(String text) {
        String plain = String.valueOf(text).replaceAll("[^ -~]", "?");
        return plain.length() > LONGEST_TEXT ? plain.substring(0, LONGEST_TEXT) : plain;
    }
}
