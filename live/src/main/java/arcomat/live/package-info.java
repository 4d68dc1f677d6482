/**
 * The tool in a browser: what the live page asks, as texts in JSON. Everything is answered by the
 * rooms of the tool itself, in the thread that asks; nothing here reads, writes or waits.
 */
package arcomat.live;
