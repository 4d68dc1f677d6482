package arcomat.generate.template;

import freemarker.cache.StringTemplateLoader;
import freemarker.core.ParseException;
import freemarker.core.TemplateClassResolver;
import freemarker.template.Configuration;
import freemarker.template.Template;
import freemarker.template.TemplateException;
import freemarker.template.TemplateExceptionHandler;
import freemarker.template.TemplateNotFoundException;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.time.Duration;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;

/**
 * The only place that knows FreeMarker. Templates come from memory, cannot create objects, cannot
 * reach the JVM, and print the same text whatever the machine's locale and time zone.
 */
public final class TemplateEngine {
    /** For one file: ten times what one of thousands of parts needs on a busy machine. */
    private static final Duration LIMIT = Duration.ofSeconds(30);

    private final Configuration configuration;
    private final LimitedWork work;
    private final Duration limit;

    /**
     * @param templates texts by name
     */
    public TemplateEngine(Map<String, String> templates) {
        this(templates, LIMIT);
    }

    /**
     * @param limit of the time for one file
     */
    TemplateEngine(Map<String, String> templates, Duration limit) {
        this.limit = limit;
        work = new LimitedWork(limit);
        StringTemplateLoader loader = new StringTemplateLoader();
        templates.forEach(loader::putTemplate);
        configuration = new InterruptibleTemplates(Configuration.VERSION_2_3_34);
        configuration.setTemplateLoader(loader);
        configuration.setObjectWrapper(new ViewWrapper());
        configuration.setNewBuiltinClassResolver(TemplateClassResolver.ALLOWS_NOTHING_RESOLVER);
        configuration.setAPIBuiltinEnabled(false);
        configuration.setLocalizedLookup(false);
        configuration.setLocale(Locale.ROOT);
        configuration.setNumberFormat("computer");
        configuration.setTemplateExceptionHandler(TemplateExceptionHandler.RETHROW_HANDLER);
        configuration.setLogTemplateExceptions(false);
        configuration.setWrapUncheckedExceptions(true);
    }

    /**
     * Fills a template in.
     *
     * @param view what the template sees, its components by name
     * @throws TemplateFailure where the template cannot be read or filled in
     */
    public String render(String template, Record view) {
        try {
            return work.run(() -> fill(template, view));
        } catch (TimeoutException e) {
            throw new TemplateFailure(
                    template,
                    0,
                    0,
                    "it has not ended after "
                            + limit.toSeconds()
                            + " seconds; does each of its loops have an end?");
        } catch (ExecutionException e) {
            if (e.getCause() instanceof Error error) {
                throw error;
            }
            throw (RuntimeException) e.getCause(); // the work throws no others
        }
    }

    private String fill(String template, Record view) {
        try {
            Template parsed = configuration.getTemplate(template);
            LimitedText text = new LimitedText();
            parsed.process(view, text);
            return text.toString().replace("\r\n", "\n");
        } catch (ParseException e) {
            throw new TemplateFailure(
                    nameOr(e.getTemplateName(), template),
                    e.getLineNumber(),
                    e.getColumnNumber(),
                    firstParagraph(e.getEditorMessage()));
        } catch (TemplateException e) {
            throw new TemplateFailure(
                    nameOr(e.getTemplateSourceName(), template),
                    orZero(e.getLineNumber()),
                    orZero(e.getColumnNumber()),
                    firstParagraph(e.getMessageWithoutStackTop()));
        } catch (TemplateNotFoundException e) {
            throw new TemplateFailure(template, 0, 0, "there is no such template");
        } catch (IOException e) {
            throw new TemplateFailure(template, 0, 0, firstParagraph(e.getMessage()));
        } catch (StackOverflowError e) {
            throw new TemplateFailure(
                    template, 0, 0, "a macro or function calls itself without end");
        }
    }

    private static String nameOr(@Nullable String name, String otherwise) {
        return name == null ? otherwise : name;
    }

    private static int orZero(@Nullable Integer number) {
        return number == null ? 0 : number;
    }

    /** What FreeMarker adds after the first paragraph are hints for its own users. */
    private static String firstParagraph(@Nullable String message) {
        String text = message == null ? "" : message.strip();
        int end = text.indexOf("\n\n");
        int hint = text.indexOf("\n----");
        int cut = end < 0 ? hint : hint < 0 ? end : Math.min(end, hint);
        return (cut < 0 ? text : text.substring(0, cut)).replaceAll("\\s+", " ");
    }
}
