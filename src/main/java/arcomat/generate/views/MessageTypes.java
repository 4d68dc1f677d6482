package arcomat.generate.views;

import arcomat.generate.language.FileReferences;
import arcomat.generate.language.TargetNames;
import arcomat.generate.language.TypeName;
import arcomat.generate.plan.Program;
import arcomat.generate.text.FileContext;
import arcomat.generate.text.LiteralWriter;
import arcomat.generate.text.MentionedTypes;
import arcomat.generate.view.ClassView;
import arcomat.generate.view.EnumView;
import arcomat.model.Type;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The views of the enums and classes that messages are made of. */
public final class MessageTypes {
    private final TargetNames names;
    private final Map<String, Type> all = new LinkedHashMap<>();

    /** Those of programs that have the same names. */
    public MessageTypes(Program... programs) {
        names = programs[0].names();
        for (Program program : programs) {
            for (FileContext context : program.contexts()) {
                MentionedTypes.of(context.component(), context.composition()).forEach(this::add);
            }
        }
    }

    private void add(Type type) {
        if (all.putIfAbsent(type.name(), type) == null && type instanceof Type.ClassType object) {
            MentionedTypes.of(object).forEach(this::add);
        }
    }

    public List<EnumView> enums() {
        return all.values().stream()
                .filter(Type.EnumType.class::isInstance)
                .map(Type.EnumType.class::cast)
                .map(this::view)
                .toList();
    }

    private EnumView view(Type.EnumType type) {
        List<EnumView.ConstantView> constants = new ArrayList<>();
        for (String constant : type.constants()) {
            TargetNames.EnumConstant name = names.constant(type, constants.size());
            int number = constants.size() + 1;
            constants.add(new EnumView.ConstantView(name.name(), name.code(), number, constant));
        }
        return new EnumView(names.of(type), type.name(), constants);
    }

    public List<ClassView> classes() {
        return all.values().stream()
                .filter(type -> !names.language().namesJava(type))
                .filter(Type.ClassType.class::isInstance)
                .map(Type.ClassType.class::cast)
                .map(this::view)
                .toList();
    }

    private ClassView view(Type.ClassType type) {
        TypeName self = names.of(type);
        FileReferences references = new FileReferences(names.language(), self);
        LiteralWriter text = new LiteralWriter(names, references);
        List<ClassView.AttributeView> attributes = new ArrayList<>();
        for (Type.Attribute attribute : type.attributes()) {
            attributes.add(
                    new ClassView.AttributeView(
                            text.type(attribute.type()),
                            names.attribute(type, attributes.size()),
                            names.language().kind(attribute.type())));
        }
        List<Type> types = type.attributes().stream().map(Type.Attribute::type).toList();
        return new ClassView(
                self,
                type.name(),
                Heads.mentions(references, Set.of(), names.ofEnums(types)),
                attributes);
    }
}
