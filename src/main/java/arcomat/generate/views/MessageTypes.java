package arcomat.generate.views;

import arcomat.generate.language.FileReferences;
import arcomat.generate.language.TargetLanguage;
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
import java.util.function.Function;

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

    private <T extends Type, V> List<V> views(Class<T> kind, Function<T, V> view) {
        return all.values().stream().filter(kind::isInstance).map(kind::cast).map(view).toList();
    }

    public List<EnumView> enums() {
        return views(Type.EnumType.class, this::view);
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
        return views(Type.ClassType.class, this::view);
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
                            TargetLanguage.kind(attribute.type())));
        }
        List<Type> types = type.attributes().stream().map(Type.Attribute::type).toList();
        return new ClassView(
                self,
                type.name(),
                Heads.mentions(references, Set.of(), names.ofEnums(types)),
                attributes);
    }
}
