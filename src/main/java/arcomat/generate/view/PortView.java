package arcomat.generate.view;

/**
 * A port.
 *
 * @param type of the field that holds the message
 * @param flag of the field that says whether there is a message; empty where the port needs none
 * @param delay of an output: 1 if the field shows in the next slice what was sent in this one
 * @param comment the declaration in the model
 */
public record PortView(
        String name,
        String type,
        String flag,
        String kind,
        boolean total,
        int delay,
        String comment) {}
