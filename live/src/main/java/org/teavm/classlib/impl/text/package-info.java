/**
 * What a browser does by itself, in place of classes of TeaVM's library of the same names: those
 * carry tables of all powers of ten, 17 kB of the page.
 */
package org.teavm.classlib.impl.text;
