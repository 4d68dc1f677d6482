package arcomat.generate.template;

import freemarker.core._CoreAPI;
import freemarker.template.Configuration;
import freemarker.template.Template;
import freemarker.template.Version;

import java.io.IOException;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Locale;
import java.util.Set;

/** Templates whose loops look whether their thread is to stop; those that are included, too. */
final class InterruptibleTemplates extends Configuration {
    private final Set<Template> prepared = Collections.newSetFromMap(new IdentityHashMap<>());

    InterruptibleTemplates(Version version) {
        super(version);
    }

    /** All ways to a template lead here. */
    @Override
    public Template getTemplate(
            String name,
            Locale locale,
            Object condition,
            String encoding,
            boolean parse,
            boolean ignoreMissing)
            throws IOException {
        Template template =
                super.getTemplate(name, locale, condition, encoding, parse, ignoreMissing);
        if (template != null && prepared.add(template)) {
            _CoreAPI.addThreadInterruptedChecks(template);
        }
        return template;
    }
}
