/**
 * Parts that both ways to find neighbours share. {@code FreeFlights} is the bodies in free flight as the event loop
 * sees them, {@code ImpactSearch} the earliest impact of a body in the arithmetic of the rung.
 */
package steward.physics.event.flight;
