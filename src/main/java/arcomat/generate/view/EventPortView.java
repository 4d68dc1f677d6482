package arcomat.generate.view;

/**
 * A port of an event-driven component.
 *
 * @param method takes a message in, or sends one
 * @param first of a latched port, what it holds before its first message; else empty
 * @param buffer field with the messages that wait; empty for outputs and latched ports
 * @param number of the port among the inputs
 * @param literal its name in the model as a literal of the target
 */
public record EventPortView(
        PortView port,
        String method,
        String first,
        String buffer,
        boolean latched,
        int number,
        String literal) {}
