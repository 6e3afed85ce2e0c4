package steward.cli.sequential;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import steward.contest.Contest.Entrant;
import steward.contest.Contest;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.league.BotIdentity;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.match.Protocol;

/** Opponents of a test: bots of a league, programs of a folder, or bots by their names. */
final class Pool {

    private static final String RUN = "run";

    private Pool() { }

    /**
     * Finds those who play, each under a name of its own: the tested ones, then the opponents. Nothing is started.
     *
     * @param bots    who are tested; an opponent with the same program is left out, and so is one that is named twice
     * @param folders of theirs
     * @param typed   the folder of a league, another folder, or names apart by commas
     * @param into    the league whose bots may be named, or {@code null}
     * @param usual   the protocol of bots without a prefix
     * @throws InputException if there is no opponent, or a bot cannot be started
     */
    static List<Entrant> find(List<String> bots, List<Path> folders, String typed, Path into, Protocol usual) {
        List<Entrant> all = new ArrayList<>();
        for (int k = 0; k < bots.size(); k++) {
            all.add(Contest.entrant(bots.get(k), folders.get(k), null, usual));
            if (all.get(k).problem() != null) {
                throw new InputException(all.get(k).problem());
            }
        }
        all.addAll(opponents(typed, into, usual, all));
        Set<String> names = new HashSet<>();
        for (int k = 0; k < all.size(); k++) {
            String name = all.get(k).name();
            for (int copy = 2; !names.add(name); copy++) {
                name = all.get(k).name() + "-" + copy;
            }
            all.set(k, all.get(k).named(name));
        }
        return all;
    }

    private static List<Entrant> opponents(String typed, Path into, Protocol usual, List<Entrant> tested) {
        Path path = OutputFiles.path(typed);
        List<Entrant> found = !Files.isDirectory(path) ? named(typed, into, usual)
            : Files.isRegularFile(path.resolve(LeagueFolder.SETTINGS)) ? ofLeague(LeagueFolder.open(path).read())
            : ofFolder(path, usual);
        for (Entrant bot : found) {
            if (bot.problem() != null) {
                throw new InputException("--pool: " + bot.problem());
            }
        }
        Set<String> known = new HashSet<>();
        tested.forEach(bot -> known.add(key(bot)));
        List<Entrant> others = found.stream().filter(bot -> known.add(key(bot))).toList();
        if (others.isEmpty()) {
            throw new InputException("--pool: found no bot in " + typed + (found.isEmpty() ? "" : " but those that are "
                + "tested") + ", expected a league, a folder of programs, or names such as builtin:racer,./other");
        }
        return others;
    }

    /** Key of a program: each is an opponent once, however often it is named. */
    private static String key(Entrant bot) {
        return BotIdentity.ofProgram(bot) + (bot.program().named() == null ? "" : bot.program().folder());
    }

    private static List<Entrant> ofLeague(LeagueSettings settings) {
        return settings.active().stream().map(LeagueBot::entrant).toList();
    }

    /** Programs that can be started, and folders whose file {@code run} holds a command. */
    private static List<Entrant> ofFolder(Path folder, Protocol usual) {
        List<Entrant> bots = new ArrayList<>();
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.sorted().toList()) {
                String name = file.getFileName().toString();
                if (Files.isRegularFile(file.resolve(RUN))) {
                    bots.add(Contest.entrant(name + "=" + Files.readString(file.resolve(RUN)).strip(), file, null,
                        usual));
                } else if (Files.isRegularFile(file) && Files.isExecutable(file)) {
                    bots.add(Contest.entrant(name + "=./'" + name + "'", folder, null, usual));
                }
            }
        } catch (IOException problem) {
            throw new InputException("--pool: " + folder + ": cannot be read: " + OutputFiles.reason(folder, problem));
        }
        return bots;
    }

    private static List<Entrant> named(String typed, Path into, Protocol usual) {
        LeagueSettings settings = into == null ? null : LeagueFolder.open(into).read();
        List<Entrant> bots = new ArrayList<>();
        for (String name : typed.split(",")) {
            bots.add(settings != null && settings.bot(name.strip()).isPresent()
                ? settings.bot(name.strip()).get().entrant() : Contest.entrant(name.strip(), usual));
        }
        return bots;
    }
}
