package arcomat.generate.view;

import arcomat.generate.language.TypeName;

import java.util.List;

/**
 * What every generated component has.
 *
 * @param model qualified name in the model
 * @param file path of the model file
 * @param line of the declaration in it
 * @param draws whether the generator of choices is a parameter
 * @param mentions types that the file names briefly
 */
public record HeadView(
        TypeName self,
        String model,
        String file,
        int line,
        boolean draws,
        List<TypeView> mentions,
        List<FieldView> parameters,
        List<PortView> inputs,
        List<PortView> outputs) {
    /**
     * A type that a file mentions.
     *
     * @param neighbour whether it lives in the package of the file
     * @param kind {@code enum}, {@code class} or {@code component}
     */
    public record TypeView(TypeName self, boolean neighbour, String kind) {}

    /**
     * A parameter, variable or constant.
     *
     * @param initial its first value, empty for a parameter
     */
    public record FieldView(String type, String name, String initial, String comment) {}

    /** A field and the value that it gets. */
    public record AssignmentView(String target, String value) {}

    /**
     * A port.
     *
     * @param type of the field that holds the message
     * @param flag of the field that says whether there is a message; empty where the port needs
     *     none
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
}
