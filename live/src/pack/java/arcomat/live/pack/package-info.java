/** Makes the live page: no part of it, and no part of the tool. */
package arcomat.live.pack;
