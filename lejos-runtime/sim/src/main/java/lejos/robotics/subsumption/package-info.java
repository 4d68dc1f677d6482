/** Behaviours that take control from each other; signatures as on the real brick. */
package lejos.robotics.subsumption;
