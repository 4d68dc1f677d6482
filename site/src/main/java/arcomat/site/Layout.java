package arcomat.site;

import freemarker.core.HTMLOutputFormat;
import freemarker.template.Configuration;
import freemarker.template.Template;
import freemarker.template.TemplateException;

import java.io.IOException;
import java.io.StringWriter;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** What stands around each page. */
final class Layout {
    private final Repository repository;
    private final String version;
    private final Navigation navigation;
    private final Template template;

    Layout(Repository repository, String version, Navigation navigation) throws IOException {
        this.repository = repository;
        this.version = version;
        this.navigation = navigation;
        Configuration configuration = new Configuration(Configuration.VERSION_2_3_34);
        configuration.setClassForTemplateLoading(Layout.class, "/site");
        configuration.setDefaultEncoding("UTF-8");
        configuration.setOutputFormat(HTMLOutputFormat.INSTANCE);
        configuration.setLocale(Locale.ROOT);
        template = configuration.getTemplate("page.ftl");
    }

    String html(Page page) throws IOException {
        List<Navigation.Entry> order = navigation.entries();
        int at = order.stream().map(Navigation.Entry::address).toList().indexOf(page.address());
        Map<String, Object> model = new HashMap<>();
        model.put("root", Addresses.between(page.address(), ""));
        model.put("page", page);
        model.put("address", page.address());
        model.put("version", version);
        model.put("source", Addresses.text(page.path()));
        model.put("sourceAddress", repository.outside(page.path()));
        model.put("groups", navigation.groups());
        if (at > 0) {
            model.put("before", order.get(at - 1));
        }
        if (at >= 0 && at < order.size() - 1) {
            model.put("after", order.get(at + 1));
        }
        StringWriter html = new StringWriter();
        try {
            template.process(model, html);
        } catch (TemplateException e) {
            throw new AssertionError(e);
        }
        return html.toString();
    }
}
