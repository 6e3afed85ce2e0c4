/** Bots on their way to another machine: their files under the hash of all of them. */
package steward.machines.bundle;
