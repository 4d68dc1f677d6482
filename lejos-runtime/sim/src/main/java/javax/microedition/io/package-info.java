/** The interfaces of connections that the brick's Java has and a PC's has not. */
package javax.microedition.io;
