/** Apache ActiveMQ Artemis, embedded: a league's broker, and a worker's connection. Nothing else knows it. */
package steward.machines.broker;
