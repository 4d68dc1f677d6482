package arcomat.generate;

import arcomat.generate.language.Names;
import arcomat.generate.language.References;
import arcomat.generate.language.TypeName;
import arcomat.generate.view.ClassView;
import arcomat.generate.view.EnumView;
import arcomat.model.Type;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The views of the enums and classes that messages are made of. */
final class MessageTypes {
    private final Names names;
    private final Map<String, Type> all = new LinkedHashMap<>();

    MessageTypes(Program program) {
        names = program.names();
        add(program);
    }

    /** Those of a further program as well; it has the same names. */
    void add(Program program) {
        for (FileContext context : program.contexts()) {
            MentionedTypes.of(context.component(), context.composition()).forEach(this::add);
        }
    }

    private void add(Type type) {
        if (all.putIfAbsent(type.name(), type) == null && type instanceof Type.ClassType object) {
            MentionedTypes.of(object).forEach(this::add);
        }
    }

    List<EnumView> enums() {
        List<EnumView> views = new ArrayList<>();
        for (Type type : all.values()) {
            if (type instanceof Type.EnumType enumeration) {
                views.add(view(enumeration));
            }
        }
        return views;
    }

    private EnumView view(Type.EnumType type) {
        List<EnumView.ConstantView> constants = new ArrayList<>();
        for (int i = 0; i < type.constants().size(); i++) {
            Names.EnumConstant name = names.constant(type, i);
            constants.add(
                    new EnumView.ConstantView(
                            name.name(), name.code(), i + 1, type.constants().get(i)));
        }
        TypeName self = names.of(type);
        return new EnumView(
                self.packageName(),
                self.prefix(),
                self.folder(),
                self.name(),
                type.name(),
                constants);
    }

    List<ClassView> classes() {
        List<ClassView> views = new ArrayList<>();
        for (Type type : all.values()) {
            if (type instanceof Type.ClassType object) {
                views.add(view(object));
            }
        }
        return views;
    }

    private ClassView view(Type.ClassType type) {
        TypeName self = names.of(type);
        References references = new References(names.language(), self);
        ExpressionText text = new ExpressionText(names, references, null);
        List<ClassView.AttributeView> attributes = new ArrayList<>();
        Set<TypeName> enums = new HashSet<>();
        for (int i = 0; i < type.attributes().size(); i++) {
            Type attribute = type.attributes().get(i).type();
            if (attribute instanceof Type.EnumType) {
                enums.add(names.of(attribute));
            }
            attributes.add(
                    new ClassView.AttributeView(
                            text.type(attribute),
                            names.attribute(type, i),
                            arcomat.generate.language.Language.kind(attribute)));
        }
        return new ClassView(
                self.packageName(),
                self.prefix(),
                self.folder(),
                self.name(),
                type.name(),
                Heads.mentions(references, Set.of(), enums),
                attributes);
    }
}
