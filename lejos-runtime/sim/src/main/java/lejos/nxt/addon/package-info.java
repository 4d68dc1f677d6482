/** Sensors of other makers; signatures as on the real brick. */
package lejos.nxt.addon;
