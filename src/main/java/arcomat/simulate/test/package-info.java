/**
 * Stream tests against a model, of slices or of events: whether one of the runs that the model
 * allows is the expected one; and runs written down as tests.
 */
package arcomat.simulate.test;
