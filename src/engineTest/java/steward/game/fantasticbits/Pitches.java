package steward.game.fantasticbits;

/** Games of Fantastic Bits on pitches of tests. */
final class Pitches {

    private Pitches() { }

    /** A game on another pitch, with other scores and magic. */
    static FantasticBits game(FantasticBits of, Pitch pitch, int[] scores, int... magic) {
        FantasticBits game = new FantasticBits(of, pitch);
        System.arraycopy(scores, 0, game.scores, 0, scores.length);
        System.arraycopy(magic, 0, game.magic, 0, magic.length);
        return game;
    }
}
