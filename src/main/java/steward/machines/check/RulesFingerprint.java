package steward.machines.check;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.numerics.SplitMix64;
import steward.numerics.StateHash;

/**
 * Fingerprint of a program's rules in a scene: a hash of all states of a few short games, played by built-in pilots of
 * all kinds. It differs between two programs if these games show a difference of rules, physics or starts, or if the
 * programs send games in different forms. For a guest it covers the form alone: its rules are its files.
 */
public final class RulesFingerprint {

    /** The form of what is sent, jobs and games ({@link TranscriptWriter}): each change gives it another number. */
    private static final int FORM = 2;
    private static final int TURNS = 40;
    private static final int SEEDS = 3;

    private RulesFingerprint() { }

    /** 16 hexadecimal digits. */
    public static String of(GameSetup setup) {
        StateHash hash = new StateHash().add(FORM);
        setup.edition().chars().forEach(hash::add);    // the games may be too short to tell
        for (Pilot.Aim aim : setup.isGuest() ? new Pilot.Aim[0] : Pilot.Aim.values()) {
            Pilot pilot = setup.pilot(aim);
            for (int seed = 0; seed < SEEDS; seed++) {
                play(setup.create(seed), setup, pilot, new SplitMix64(seed), hash);
            }
        }
        return StateHash.toHex(hash.value());
    }

    private static void play(Game game, GameSetup setup, Pilot pilot, SplitMix64 random, StateHash hash) {
        GameJson codec = setup.codec(game);
        hash.add(game.hash());
        while (!game.isOver() && game.turn() < TURNS) {
            List<byte[]> answers = new ArrayList<>();
            for (int player = 0; player < game.players(); player++) {
                answers.add(game.isIn(player) ? pilot.answer(game, player, random).getBytes(StandardCharsets.UTF_8)
                    : null);
            }
            for (int player = 0; player < game.players(); player++) {
                byte[] answer = answers.get(player);
                String wrong = answer == null ? null : codec.readAnswer(player, answer, answer.length);
                if (wrong != null) {
                    game.eliminate(player, wrong);
                }
            }
            game.play();
            hash.add(game.hash());
        }
        for (int player = 0; player < game.players(); player++) {
            hash.add(game.ranks()[player]).add(game.scores()[player]);
        }
    }
}
