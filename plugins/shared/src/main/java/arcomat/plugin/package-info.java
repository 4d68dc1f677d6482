/** What plugins of builds have in common, whichever build it is: compiled into each of them. */
package arcomat.plugin;
