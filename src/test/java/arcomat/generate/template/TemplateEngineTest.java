package arcomat.generate.template;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.time.Duration;
import java.util.Map;

/** Templates without an end; those that a test of targets cannot wait for. */
class TemplateEngineTest {
    /** What a template sees. */
    public record View(String name) {}

    private static final Map<String, String> TEMPLATES =
            Map.of(
                    "endless.ftl", "<#list 1.. as x></#list>",
                    "including.ftl", "<#include 'endless.ftl'>",
                    "growing.ftl", "<#list 1.. as x>${name}</#list>",
                    "good.ftl", "Hello ${name}",
                    "deep.ftl", "<#macro m><@m/></#macro><@m/>");

    private final TemplateEngine engine = new TemplateEngine(TEMPLATES, Duration.ofSeconds(1));

    @Tag("slow")
    @Test
    @Timeout(60)
    void aTemplateThatDoesNotEndIsLeftAndOthersGoOn() throws Exception {
        for (String template : new String[] {"endless.ftl", "including.ftl"}) {
            assertThatThrownBy(() -> engine.render(template, new View("you")))
                    .isInstanceOf(TemplateFailure.class)
                    .hasMessageContaining("not ended after 1 seconds");
            assertThat(engine.render("good.ftl", new View("you"))).isEqualTo("Hello you");
        }
        while (isAtWork()) {
            Thread.sleep(100); // until the loops have seen that they are to stop
        }
    }

    /** Before the memory is full. */
    @Test
    @Timeout(60)
    void aTemplateThatWritesWithoutAnEndIsLeft() {
        TemplateEngine patient = new TemplateEngine(TEMPLATES, Duration.ofSeconds(50));
        assertThatThrownBy(() -> patient.render("growing.ftl", new View("x".repeat(1 << 20))))
                .isInstanceOf(TemplateFailure.class)
                .hasMessageContaining("writes more than 64 million characters");
    }

    private static boolean isAtWork() {
        return Thread.getAllStackTraces().keySet().stream()
                .anyMatch(
                        thread ->
                                thread.getName().equals("arcomat-template")
                                        && thread.getState() == Thread.State.RUNNABLE);
    }

    @Test
    void whatFailsInsideFailsOutside() {
        TemplateEngine patient = new TemplateEngine(TEMPLATES, Duration.ofSeconds(50));
        assertThatThrownBy(() -> patient.render("deep.ftl", new View("you")))
                .isInstanceOf(TemplateFailure.class)
                .hasMessageContaining("calls itself without end");
    }
}
