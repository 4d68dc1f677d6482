package arcomat.report.page;

import org.openqa.selenium.By;
import org.openqa.selenium.JavascriptExecutor;
import org.openqa.selenium.Keys;
import org.openqa.selenium.NotFoundException;
import org.openqa.selenium.OutputType;
import org.openqa.selenium.StaleElementReferenceException;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.chrome.ChromeDriver;
import org.openqa.selenium.chrome.ChromeDriverService;
import org.openqa.selenium.chrome.ChromeOptions;
import org.openqa.selenium.interactions.Actions;
import org.openqa.selenium.logging.LogEntry;
import org.openqa.selenium.logging.LogType;
import org.openqa.selenium.logging.LoggingPreferences;
import org.openqa.selenium.print.PageSize;
import org.openqa.selenium.print.PrintOptions;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;
import java.util.logging.Level;
import java.util.regex.Pattern;

/** Chromium without a window, with the driver that comes along. */
public final class Browser implements AutoCloseable {
    private static final Duration PATIENCE = Duration.ofSeconds(60);

    private static final Duration PAUSE = Duration.ofMillis(20);

    private final ChromeDriver driver;

    private final Duration patience;

    public Browser() {
        this(PATIENCE);
    }

    /**
     * @param patience how long something is waited for
     */
    public Browser(Duration patience) {
        this.patience = patience;
        LoggingPreferences logging = new LoggingPreferences();
        logging.enable(LogType.BROWSER, Level.ALL);
        ChromeOptions options = new ChromeOptions();
        options.setBinary(program("chromium").orElseThrow().toFile());
        options.addArguments(
                "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage");
        options.addArguments("--window-size=1500,1200");
        options.setCapability("goog:loggingPrefs", logging);
        File program = program("chromedriver").orElseThrow().toFile();
        ChromeDriverService service =
                new ChromeDriverService.Builder().usingDriverExecutable(program).build();
        driver = new ChromeDriver(service, options);
    }

    public static boolean isThere() {
        return program("chromium").isPresent() && program("chromedriver").isPresent();
    }

    private static Optional<Path> program(String name) {
        String path = Optional.ofNullable(System.getenv("PATH")).orElse("");
        return Arrays.stream(path.split(File.pathSeparator))
                .map(folder -> Path.of(folder, name))
                .filter(Files::isExecutable)
                .findFirst();
    }

    /** Opens a page and waits until it has begun. */
    public void open(Path page) {
        open(page.toUri().toString(), "#story > *");
    }

    /** Opens an address and waits until it has what a selector asks for. */
    public void open(String address, String selector) {
        problems(); // those of other pages
        driver.get(address);
        await(() -> !driver.findElements(By.cssSelector(selector)).isEmpty());
    }

    /** What the console of the page says that is no mere information. */
    public List<String> problems() {
        return driver.manage().logs().get(LogType.BROWSER).getAll().stream()
                .filter(entry -> entry.getLevel().intValue() >= Level.WARNING.intValue())
                .map(LogEntry::getMessage)
                .toList();
    }

    /** Presses keys one after the other, wherever the focus is. */
    public void press(CharSequence... keys) {
        for (CharSequence key : keys) {
            driver.switchTo().activeElement().sendKeys(key);
        }
    }

    public void pressWithShift(Keys key) {
        press(Keys.chord(Keys.SHIFT, key));
    }

    /** Types as a person does, in whatever has the focus. */
    public void type(CharSequence text) {
        new Actions(driver).sendKeys(text).perform();
    }

    /** Presses keys all together, in whatever has the focus. */
    public void chord(List<CharSequence> keys) {
        Actions actions = new Actions(driver);
        keys.forEach(actions::keyDown);
        keys.forEach(actions::keyUp);
        actions.perform();
    }

    /** Takes what a selector finds first, and puts it down so many pixels further below. */
    public void drag(String selector, int down) {
        new Actions(driver).dragAndDropBy(find(selector), 0, down).perform();
    }

    /** Whether something is so in some frame: in one that lies within one that a selector finds. */
    public boolean inSomeFrame(String outer, String inner, Supplier<Boolean> question) {
        return findAll(outer).stream().anyMatch(frame -> inFrame(frame, inner, question));
    }

    private boolean inFrame(WebElement outer, String inner, Supplier<Boolean> question) {
        try {
            driver.switchTo().frame(outer);
            driver.switchTo().frame(find(inner));
            return question.get();
        } catch (NotFoundException | StaleElementReferenceException beingLoaded) {
            return false;
        } finally {
            driver.switchTo().defaultContent();
        }
    }

    public WebElement find(String selector) {
        return driver.findElement(By.cssSelector(selector));
    }

    public List<WebElement> findAll(String selector) {
        return driver.findElements(By.cssSelector(selector));
    }

    public String text(String selector) {
        return find(selector).getText();
    }

    public Object run(String script) {
        return ((JavascriptExecutor) driver).executeScript(script);
    }

    /** Waits until something is so; fails after a while. */
    public void await(Supplier<Boolean> condition) {
        Instant end = Instant.now().plus(patience);
        while (!condition.get()) {
            if (Instant.now().isAfter(end)) {
                throw new AssertionError("waited in vain at " + driver.getCurrentUrl());
            }
            LockSupport.parkNanos(PAUSE.toNanos());
        }
    }

    public void wear(String scheme) {
        Map<String, Object> feature = Map.of("name", "prefers-color-scheme", "value", scheme);
        driver.executeCdpCommand(
                "Emulation.setEmulatedMedia", Map.of("features", List.of(feature)));
    }

    /** As it is printed. */
    public void print() {
        driver.executeCdpCommand("Emulation.setEmulatedMedia", Map.of("media", "print"));
    }

    /** How many sheets of paper, of size A4, the page takes. */
    public int sheets() {
        PrintOptions options = new PrintOptions();
        options.setPageSize(new PageSize(29.7, 21.0));
        byte[] pdf = Base64.getDecoder().decode(driver.print(options).getContent());
        String text = new String(pdf, StandardCharsets.ISO_8859_1);
        return (int) Pattern.compile("/Type */Page\\b").matcher(text).results().count();
    }

    /** As if the window were so large, in pixels: smaller than a window can be made. */
    public void resize(int width, int height) {
        driver.executeCdpCommand(
                "Emulation.setDeviceMetricsOverride",
                Map.of("width", width, "height", height, "deviceScaleFactor", 1, "mobile", false));
    }

    /** Keeps a picture of what is to be seen, for people. */
    public void picture(String name) {
        try {
            Path folder = Files.createDirectories(Path.of("build", "reports", "pages"));
            Files.write(folder.resolve(name + ".png"), driver.getScreenshotAs(OutputType.BYTES));
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    @Override
    public void close() {
        driver.quit();
    }
}
