/** Times and choice of test cases, for all projects. Knows nothing of the tool. */
package arcomat.testing;
