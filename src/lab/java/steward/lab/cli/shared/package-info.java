/** Parts of several commands of the lab. */
package steward.lab.cli.shared;
