package steward.lab.bench;

import java.util.List;
import java.util.Locale;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import steward.lab.timing.TimedPlace;
import steward.lab.timing.Timing;
import steward.lab.timing.TimingEffort;
import steward.lab.timing.TimingSamples;
import steward.numerics.Median;

/**
 * Several ways to do the same work, measured in turns, with a row for each, whose ratio is to the first.
 *
 * @param section    that the rows belong to
 * @param unit       of the work
 * @param contenders the textbook's way first
 * @param remark     for the note of each row, by the samples and the contender's number; may be empty
 */
public record Comparison(String section, String unit, List<Contender> contenders,
                         BiFunction<TimingSamples, Integer, String> remark) {

    /** A ratio whose rounds differ by more is not to be compared: tables are for differences beyond this. */
    private static final double COMPARABLE = 1.25;
    /** With fewer rounds ratios are not compared; of each so many the lowest and the highest do not count. */
    private static final int MANY_ROUNDS = 5;

    /** Remark on how much longer than the first each takes: the median of the rounds' ratios, and the difference. */
    public static String paired(TimingSamples samples, int contender) {
        double more = samples.median(contender) - samples.median(0);
        return contender == 0 ? "" : String.format(Locale.ROOT, "%.3f times the first (median of pairs), %s%s",
            Median.of(samples.ratios(contender, 0)), more < 0 ? "-" : "+", PerformancePage.time(Math.abs(more)));
    }

    /**
     * Measures all.
     *
     * @throws Exception what a contender threw, or if this thread is interrupted: then the results of the whole rounds
     *     are reported first
     */
    public void run(TimingEffort effort, Runnable step, Consumer<Row> rows) throws Exception {
        Consumer<TimingSamples> report = samples -> report(samples, effort.rounds(), rows);
        report.accept(new Timing<>(effort, Contender::place).run(contenders, step, report));
    }

    private void report(TimingSamples samples, int rounds, Consumer<Row> rows) {
        for (int k = 0; k < contenders.size(); k++) {
            rows.accept(new Row(section, contenders.get(k).name(), unit, TimedPlace.NANOS / samples.median(k),
                contenders.size() == 1 ? Double.NaN : samples.ratio(0, k), samples.bytes(k), remark.apply(samples, k))
                .remark(samples.rounds() < rounds ? samples.rounds() + " of " + rounds + " rounds" : "")
                .remark(k == 0 ? "" : caution(samples.ratios(0, k), rounds)));
        }
    }

    /** Says that a ratio is not comparable, if its rounds are few or differ too much; otherwise nothing. */
    private static String caution(double[] ratios, int rounds) {
        int cut = ratios.length / MANY_ROUNDS;
        double low = ratios[cut];
        double high = ratios[ratios.length - 1 - cut];
        return rounds < MANY_ROUNDS ? "few rounds: ratio not comparable" : high <= COMPARABLE * low ? ""
            : String.format(Locale.ROOT, "ratio not comparable: %.2f to %.2f in its rounds", low, high);
    }
}
