/**
 * Apache ActiveMQ Artemis, embedded: the broker in a league's process, and a worker's connection to it. Nothing else
 * knows Artemis, and it is loaded by nothing but the commands that play on several machines.
 */
package steward.machines.broker;
