package arcomat.generate.view;

import arcomat.generate.language.TypeName;
import arcomat.generate.view.HeadView.TypeView;

import java.util.List;

/**
 * A class of a class diagram: messages with attributes.
 *
 * @param model qualified name in the model
 */
public record ClassView(
        TypeName self, String model, List<TypeView> mentions, List<AttributeView> attributes) {

    /**
     * An attribute.
     *
     * @param kind of its type: {@code int}, {@code string}, {@code enum} ..
     */
    public record AttributeView(String type, String name, String kind) {}
}
