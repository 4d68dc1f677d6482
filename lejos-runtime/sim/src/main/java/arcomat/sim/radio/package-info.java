/**
 * Bluetooth between simulated bricks: who can be reached, connections, packets on their way. Knows
 * virtual time only as the moment at which a packet arrives.
 */
package arcomat.sim.radio;
