package arcomat.site;

import org.commonmark.node.FencedCodeBlock;
import org.commonmark.node.Node;
import org.commonmark.renderer.NodeRenderer;
import org.commonmark.renderer.html.HtmlNodeRendererContext;
import org.commonmark.renderer.html.HtmlWriter;

import java.util.Map;
import java.util.Set;

/**
 * Blocks of code with a line above that says what they are: a file and where to try it, or a
 * terminal.
 *
 * @param address of their page
 */
record Blocks(Trials trials, String address) {
    NodeRenderer renderer(HtmlNodeRendererContext context) {
        return new NodeRenderer() {
            @Override
            public Set<Class<? extends Node>> getNodeTypes() {
                return Set.of(FencedCodeBlock.class);
            }

            @Override
            public void render(Node node) {
                render((FencedCodeBlock) node, context.getWriter());
            }

            private void render(FencedCodeBlock block, HtmlWriter html) {
                Fenced fenced = Fenced.of(block);
                html.line();
                html.tag("div", Map.of("class", "block " + fenced.language()));
                html.tag("p", Map.of("class", "bar"));
                html.tag("span");
                html.text(fenced.isConsole() ? "terminal" : fenced.caption());
                html.tag("/span");
                trials.of(block)
                        .ifPresent(
                                trial -> {
                                    String live = Addresses.between(address, "live/index.html");
                                    html.tag(
                                            "a",
                                            Map.of(
                                                    "class",
                                                    "try",
                                                    "href",
                                                    live + "#" + trial.packed()));
                                    html.text("Try it");
                                    html.tag("/a");
                                });
                html.tag("/p");
                html.tag("pre");
                html.tag("code");
                html.raw(inside(fenced));
                html.tag("/code");
                html.tag("/pre");
                html.tag("/div");
                html.line();
            }
        };
    }

    private String inside(Fenced fenced) {
        if (fenced.isConsole()) {
            return new Transcript(address).html(fenced.text());
        }
        return fenced.isModel() ? Colours.html(fenced.text()) : Colours.escaped(fenced.text());
    }
}
