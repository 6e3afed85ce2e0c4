/** Messages between a league and its workers: a header in JSON, read strictly, and bytes behind it. */
package steward.machines.wire;
