package steward.lab.stability;

import steward.lab.trial.RunLength;

/**
 * A run of the stability table.
 *
 * @param length how much work each case had
 * @param date   when, as year-month-day
 */
public record StabilityRun(RunLength length, String date, String version, String machine) { }
