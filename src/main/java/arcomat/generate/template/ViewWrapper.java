package arcomat.generate.template;

import arcomat.generate.language.TypeName;

import freemarker.template.ObjectWrapper;
import freemarker.template.SimpleNumber;
import freemarker.template.SimpleScalar;
import freemarker.template.TemplateBooleanModel;
import freemarker.template.TemplateHashModel;
import freemarker.template.TemplateModel;
import freemarker.template.TemplateModelException;
import freemarker.template.TemplateSequenceModel;

import org.jspecify.annotations.Nullable;

import java.lang.reflect.RecordComponent;
import java.util.List;

/**
 * Shows templates the components of records, lists, texts, numbers and truth values, and nothing
 * else: no method and no class of the JVM can be reached from a template, a user's own included.
 */
final class ViewWrapper implements ObjectWrapper {
    @Override
    public TemplateModel wrap(Object value) throws TemplateModelException {
        if (value instanceof String text) {
            return new SimpleScalar(text);
        }
        if (value instanceof Number number) {
            return new SimpleNumber(number);
        }
        if (value instanceof Boolean truth) {
            return truth ? TemplateBooleanModel.TRUE : TemplateBooleanModel.FALSE;
        }
        if (value instanceof List<?> list) {
            return new ListModel(this, list);
        }
        if (value instanceof Record view) {
            return new RecordModel(this, view);
        }
        if (value == null || value instanceof TemplateModel) {
            return (TemplateModel) value;
        }
        throw new TemplateModelException("not a view: " + value.getClass());
    }

    private record ListModel(ViewWrapper wrapper, List<?> list) implements TemplateSequenceModel {
        @Override
        public TemplateModel get(int index) throws TemplateModelException {
            return wrapper.wrap(list.get(index)); // FreeMarker has looked at the size
        }

        @Override
        public int size() {
            return list.size();
        }
    }

    private record RecordModel(ViewWrapper wrapper, Record view) implements TemplateHashModel {
        @Override
        public @Nullable TemplateModel get(String name) throws TemplateModelException {
            for (RecordComponent component : view.getClass().getRecordComponents()) {
                if (component.getName().equals(name)) {
                    return wrapper.wrap(read(component));
                }
            }
            for (RecordComponent component : view.getClass().getRecordComponents()) {
                if (component.getType() == TypeName.class) {
                    return new RecordModel(wrapper, (TypeName) read(component)).get(name);
                }
            }
            return null;
        }

        private Object read(RecordComponent component) throws TemplateModelException {
            try {
                return component.getAccessor().invoke(view);
            } catch (ReflectiveOperationException e) {
                throw new TemplateModelException("cannot read " + component.getName(), e);
            }
        }

        @Override
        public boolean isEmpty() {
            return false;
        }
    }
}
