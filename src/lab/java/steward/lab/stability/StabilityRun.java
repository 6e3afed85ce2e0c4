package steward.lab.stability;

import steward.lab.trial.RunLength;

/**
 * Conditions of a run of the stability table: amount of work, date, version and machine.
 *
 * @param length how much work each case had
 * @param date   when, as year-month-day
 */
public record StabilityRun(RunLength length, String date, String version, String machine) { }
