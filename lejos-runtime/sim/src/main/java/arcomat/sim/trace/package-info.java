/** What a program did with its brick, as data. Knows the devices only as their observer. */
package arcomat.sim.trace;
