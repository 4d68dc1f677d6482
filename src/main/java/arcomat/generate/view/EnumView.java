package arcomat.generate.view;

import arcomat.generate.language.TypeName;

import java.util.List;

/**
 * An enum of a class diagram.
 *
 * @param model qualified name in the model
 */
public record EnumView(TypeName self, String model, List<ConstantView> constants) {

    /**
     * A constant.
     *
     * @param name of the object
     * @param code name of the number that stands for it in components
     * @param number from 1; 0 is no message
     */
    public record ConstantView(String name, String code, int number, String model) {}
}
