/** The walk over definitions that asks each law where it listens. Laws do not know it. */
package arcomat.check.walk;
