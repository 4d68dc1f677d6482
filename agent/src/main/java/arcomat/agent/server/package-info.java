/** Messages in and out, the time that a call has, and answers that are too long for one message. */
package arcomat.agent.server;
