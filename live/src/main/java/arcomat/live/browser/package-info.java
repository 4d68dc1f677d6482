/** The door by which scripts come in. The only package that knows that there is a browser. */
package arcomat.live.browser;
