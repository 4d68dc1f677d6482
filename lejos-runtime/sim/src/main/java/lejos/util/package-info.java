/** Waiting and measuring time on the simulated brick; signatures as on the real one. */
package lejos.util;
