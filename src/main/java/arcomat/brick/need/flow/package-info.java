/** The ways through methods: what follows what, how often loops go round, and the heaviest way. */
package arcomat.brick.need.flow;
