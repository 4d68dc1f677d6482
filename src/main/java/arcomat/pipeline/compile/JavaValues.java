package arcomat.pipeline.compile;

import arcomat.generate.CodeLayout;
import arcomat.model.Parameter;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.rt.Choice;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/** Values of models as compiled code holds them, and back. */
final class JavaValues {
    private final CompiledModel model;

    JavaValues(CompiledModel model) {
        this.model = model;
    }

    /** What the constructor of the whole takes. */
    List<Object> constructorArguments(List<Value> arguments, int seed) {
        List<Object> all = new ArrayList<>();
        if (model.place(model.component()).draws()) {
            all.add(new Choice(seed));
        }
        List<Parameter> parameters = model.component().parameters();
        for (int i = 0; i < parameters.size(); i++) {
            all.add(toJava(arguments.get(i), parameters.get(i).type()));
        }
        return all;
    }

    /** Enums become their codes, integers Java's int or long, objects those of their class. */
    Object toJava(Value value, Type type) {
        return new ToJava(type).of(value);
    }

    private Object object(Value.ObjectValue value) {
        List<Object> attributes = new ArrayList<>();
        for (int i = 0; i < value.attributes().size(); i++) {
            Type type = value.type().attributes().get(i).type();
            attributes.add(toJava(value.attributes().get(i), type));
        }
        String className = layout(value.type()).className();
        return model.instantiate(className, attributes);
    }

    private CodeLayout.MessageClass layout(Type.ClassType type) {
        return Objects.requireNonNull(model.layout().classes().get(type.name()));
    }

    Value fromJava(Object object, Type type) {
        return read().of(object, type);
    }

    /** The way back. */
    ModelValues read() {
        return new ModelValues(model.layout().classes());
    }

    /** What Java holds for a value of a type. */
    private final class ToJava implements FieldForm {
        private final Type type;

        ToJava(Type type) {
            this.type = type;
        }

        @Override
        public Type type() {
            return type;
        }

        @Override
        public Object objectValue(Value.ObjectValue value) {
            return object(value);
        }
    }
}
