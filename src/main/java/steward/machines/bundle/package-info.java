/** Transfer of bots to other machines: their files packed into bundles, each named by a hash of its contents. */
package steward.machines.bundle;
