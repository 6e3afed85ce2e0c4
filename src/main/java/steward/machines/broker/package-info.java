/**
 * Apache ActiveMQ Artemis, embedded: the broker in a league's process, and a worker's connection to it. No other
 * package uses Artemis, and only the commands that play on several machines load it.
 */
package steward.machines.broker;
