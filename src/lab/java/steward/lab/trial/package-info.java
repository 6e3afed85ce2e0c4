/** Seeded pairs and gases for measurements, and a count of their impacts. */
package steward.lab.trial;
