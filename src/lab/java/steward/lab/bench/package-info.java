/** Measuring whole matches and crowds: sections of contenders, rows of results, meters, files and page. */
package steward.lab.bench;
