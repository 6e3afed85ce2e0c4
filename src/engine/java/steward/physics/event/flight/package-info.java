/**
 * Parts that both ways to find neighbours share: {@code FreeFlights}, what the event loop asks of bodies in free
 * flight, and {@code ImpactSearch}, the earliest impact of a body in the arithmetic of the rung.
 */
package steward.physics.event.flight;
