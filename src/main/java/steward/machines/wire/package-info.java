/** Messages between a league and its workers: a JSON header, parsed strictly, and bytes behind it. */
package steward.machines.wire;
