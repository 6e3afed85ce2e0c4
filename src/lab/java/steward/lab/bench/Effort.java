package steward.lab.bench;

import steward.lab.timing.TimingEffort;

/** Effort of a measurement: repetitions and durations. */
public enum Effort {
    /** A minute in all: for ratios that differ much. */
    QUICK(new TimingEffort(1, 5, 0.02, 0.05, 1.5), 1),
    /** Minutes. */
    NORMAL(new TimingEffort(1, 7, 0.2, 3, 9), 3),
    /** For tables that are kept. */
    LONG(new TimingEffort(1, 11, 0.5, 4, 12), 5);

    private final TimingEffort timing;
    private final int few;

    Effort(TimingEffort timing, int few) {
        this.timing = timing;
        this.few = few;
    }

    /** Returns what is usual. */
    public TimingEffort timing() {
        return timing;
    }

    /** Returns the usual warm-up before few rounds, for those that take many seconds each. */
    public TimingEffort few() {
        return new TimingEffort(1, few, timing.round(), timing.warmLeast(), timing.warmMost());
    }

    /** Returns so many rounds in which programs are started, a tenth of them if quick, after a second of warm-up. */
    public TimingEffort rounds(int number) {
        return new TimingEffort(1, this == QUICK ? number / 10 : number, 0, Math.min(1, timing.warmLeast()), 1);
    }
}
