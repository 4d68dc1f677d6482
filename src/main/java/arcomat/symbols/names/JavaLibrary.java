package arcomat.symbols.names;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.StringTokenizer;

/**
 * The public types of the packages of Java 17 that models may name as messages. A table, so that a
 * model means the same whatever Java the tool runs on, and in a browser as well.
 */
final class JavaLibrary {
    /** Behind a name: how many type arguments it takes; {@code !} where it has few values. */
    private static final String TABLE =
            """
            java.io: BufferedInputStream BufferedOutputStream BufferedReader BufferedWriter
                ByteArrayInputStream ByteArrayOutputStream CharArrayReader CharArrayWriter
                CharConversionException Closeable Console DataInput DataInputStream DataOutput
                DataOutputStream EOFException Externalizable File FileDescriptor FileFilter
                FileInputStream FileNotFoundException FileOutputStream FilePermission FileReader
                FileWriter FilenameFilter FilterInputStream FilterOutputStream FilterReader
                FilterWriter Flushable IOError IOException InputStream InputStreamReader
                InterruptedIOException InvalidClassException InvalidObjectException
                LineNumberInputStream LineNumberReader NotActiveException NotSerializableException
                ObjectInput ObjectInputFilter ObjectInputFilter.Config ObjectInputFilter.FilterInfo
                ObjectInputFilter.Status! ObjectInputStream ObjectInputStream.GetField
                ObjectInputValidation ObjectOutput ObjectOutputStream ObjectOutputStream.PutField
                ObjectStreamClass ObjectStreamConstants ObjectStreamException ObjectStreamField
                OptionalDataException OutputStream OutputStreamWriter PipedInputStream
                PipedOutputStream PipedReader PipedWriter PrintStream PrintWriter
                PushbackInputStream PushbackReader RandomAccessFile Reader SequenceInputStream
                Serializable SerializablePermission StreamCorruptedException StreamTokenizer
                StringBufferInputStream StringReader StringWriter SyncFailedException
                UTFDataFormatException UncheckedIOException UnsupportedEncodingException
                WriteAbortedException Writer
            java.lang: AbstractMethodError Appendable ArithmeticException
                ArrayIndexOutOfBoundsException ArrayStoreException AssertionError AutoCloseable
                Boolean BootstrapMethodError Byte CharSequence Character Character.Subset
                Character.UnicodeBlock Character.UnicodeScript! Class/1 ClassCastException
                ClassCircularityError ClassFormatError ClassLoader ClassNotFoundException
                ClassValue/1 CloneNotSupportedException Cloneable Comparable/1 Compiler Double
                Enum.EnumDesc/1 Enum/1 EnumConstantNotPresentException Error Exception
                ExceptionInInitializerError Float IllegalAccessError IllegalAccessException
                IllegalArgumentException IllegalCallerException IllegalMonitorStateException
                IllegalStateException IllegalThreadStateException IncompatibleClassChangeError
                IndexOutOfBoundsException InheritableThreadLocal/1 InstantiationError
                InstantiationException Integer InternalError InterruptedException Iterable/1
                LayerInstantiationException LinkageError Long Math Module ModuleLayer
                ModuleLayer.Controller NegativeArraySizeException NoClassDefFoundError
                NoSuchFieldError NoSuchFieldException NoSuchMethodError NoSuchMethodException
                NullPointerException Number NumberFormatException Object OutOfMemoryError Package
                Process ProcessBuilder ProcessBuilder.Redirect ProcessBuilder.Redirect.Type!
                ProcessHandle ProcessHandle.Info Readable Record ReflectiveOperationException
                Runnable Runtime Runtime.Version RuntimeException RuntimePermission
                SecurityException SecurityManager Short StackOverflowError StackTraceElement
                StackWalker StackWalker.Option! StackWalker.StackFrame StrictMath String
                StringBuffer StringBuilder StringIndexOutOfBoundsException System System.Logger
                System.Logger.Level! System.LoggerFinder Thread Thread.State!
                Thread.UncaughtExceptionHandler ThreadDeath ThreadGroup ThreadLocal/1 Throwable
                TypeNotPresentException UnknownError UnsatisfiedLinkError
                UnsupportedClassVersionError UnsupportedOperationException VerifyError
                VirtualMachineError Void!
            java.math: BigDecimal BigInteger MathContext RoundingMode!
            java.net: Authenticator Authenticator.RequestorType! BindException CacheRequest
                CacheResponse ConnectException ContentHandler ContentHandlerFactory CookieHandler
                CookieManager CookiePolicy CookieStore DatagramPacket DatagramSocket
                DatagramSocketImpl DatagramSocketImplFactory FileNameMap HttpCookie
                HttpRetryException HttpURLConnection IDN Inet4Address Inet6Address InetAddress
                InetSocketAddress InterfaceAddress JarURLConnection MalformedURLException
                MulticastSocket NetPermission NetworkInterface NoRouteToHostException
                PasswordAuthentication PortUnreachableException ProtocolException ProtocolFamily
                Proxy Proxy.Type! ProxySelector ResponseCache SecureCacheResponse ServerSocket
                Socket SocketAddress SocketException SocketImpl SocketImplFactory SocketOption/1
                SocketOptions SocketPermission SocketTimeoutException StandardProtocolFamily!
                StandardSocketOptions URI URISyntaxException URL URLClassLoader URLConnection
                URLDecoder URLEncoder URLPermission URLStreamHandler URLStreamHandlerFactory
                UnixDomainSocketAddress UnknownHostException UnknownServiceException
            java.nio.file: AccessDeniedException AccessMode! AtomicMoveNotSupportedException
                ClosedDirectoryStreamException ClosedFileSystemException ClosedWatchServiceException
                CopyOption DirectoryIteratorException DirectoryNotEmptyException
                DirectoryStream.Filter/1 DirectoryStream/1 FileAlreadyExistsException FileStore
                FileSystem FileSystemAlreadyExistsException FileSystemException
                FileSystemLoopException FileSystemNotFoundException FileSystems FileVisitOption!
                FileVisitResult! FileVisitor/1 Files InvalidPathException LinkOption! LinkPermission
                NoSuchFileException NotDirectoryException NotLinkException OpenOption Path
                PathMatcher Paths ProviderMismatchException ProviderNotFoundException
                ReadOnlyFileSystemException SecureDirectoryStream/1 SimpleFileVisitor/1
                StandardCopyOption! StandardOpenOption! StandardWatchEventKinds WatchEvent.Kind/1
                WatchEvent.Modifier WatchEvent/1 WatchKey WatchService Watchable
            java.text: Annotation AttributedCharacterIterator AttributedCharacterIterator.Attribute
                AttributedString Bidi BreakIterator CharacterIterator ChoiceFormat
                CollationElementIterator CollationKey Collator CompactNumberFormat DateFormat
                DateFormat.Field DateFormatSymbols DecimalFormat DecimalFormatSymbols FieldPosition
                Format Format.Field MessageFormat MessageFormat.Field Normalizer Normalizer.Form!
                NumberFormat NumberFormat.Field NumberFormat.Style! ParseException ParsePosition
                RuleBasedCollator SimpleDateFormat StringCharacterIterator
            java.time: Clock DateTimeException DayOfWeek! Duration Instant InstantSource LocalDate
                LocalDateTime LocalTime Month! MonthDay OffsetDateTime OffsetTime Period Year
                YearMonth ZoneId ZoneOffset ZonedDateTime
            java.util: AbstractCollection/1 AbstractList/1 AbstractMap.SimpleEntry/2
                AbstractMap.SimpleImmutableEntry/2 AbstractMap/2 AbstractQueue/1
                AbstractSequentialList/1 AbstractSet/1 ArrayDeque/1 ArrayList/1 Arrays Base64
                Base64.Decoder Base64.Encoder BitSet Calendar Calendar.Builder Collection/1
                Collections Comparator/1 ConcurrentModificationException Currency Date Deque/1
                Dictionary/2 DoubleSummaryStatistics DuplicateFormatFlagsException
                EmptyStackException EnumMap/2 EnumSet/1 Enumeration/1 EventListener
                EventListenerProxy/1 EventObject FormatFlagsConversionMismatchException Formattable
                FormattableFlags Formatter Formatter.BigDecimalLayoutForm! FormatterClosedException
                GregorianCalendar HashMap/2 HashSet/1 Hashtable/2 HexFormat IdentityHashMap/2
                IllegalFormatCodePointException IllegalFormatConversionException
                IllegalFormatException IllegalFormatFlagsException IllegalFormatPrecisionException
                IllegalFormatWidthException IllformedLocaleException InputMismatchException
                IntSummaryStatistics InvalidPropertiesFormatException Iterator/1 LinkedHashMap/2
                LinkedHashSet/1 LinkedList/1 List/1 ListIterator/1 ListResourceBundle Locale
                Locale.Builder Locale.Category! Locale.FilteringMode! Locale.IsoCountryCode!
                Locale.LanguageRange LongSummaryStatistics Map.Entry/2 Map/2
                MissingFormatArgumentException MissingFormatWidthException MissingResourceException
                NavigableMap/2 NavigableSet/1 NoSuchElementException Objects Observable Observer
                Optional/1 OptionalDouble OptionalInt OptionalLong PrimitiveIterator.OfDouble
                PrimitiveIterator.OfInt PrimitiveIterator.OfLong PrimitiveIterator/2 PriorityQueue/1
                Properties PropertyPermission PropertyResourceBundle Queue/1 Random RandomAccess
                ResourceBundle ResourceBundle.Control Scanner ServiceConfigurationError
                ServiceLoader.Provider/1 ServiceLoader/1 Set/1 SimpleTimeZone SortedMap/2
                SortedSet/1 Spliterator.OfDouble Spliterator.OfInt Spliterator.OfLong
                Spliterator.OfPrimitive/3 Spliterator/1 Spliterators
                Spliterators.AbstractDoubleSpliterator Spliterators.AbstractIntSpliterator
                Spliterators.AbstractLongSpliterator Spliterators.AbstractSpliterator/1
                SplittableRandom Stack/1 StringJoiner StringTokenizer TimeZone Timer TimerTask
                TooManyListenersException TreeMap/2 TreeSet/1 UUID UnknownFormatConversionException
                UnknownFormatFlagsException Vector/1 WeakHashMap/2
            java.util.concurrent: AbstractExecutorService ArrayBlockingQueue/1 BlockingDeque/1
                BlockingQueue/1 BrokenBarrierException Callable/1 CancellationException
                CompletableFuture.AsynchronousCompletionTask CompletableFuture/1 CompletionException
                CompletionService/1 CompletionStage/1 ConcurrentHashMap.KeySetView/2
                ConcurrentHashMap/2 ConcurrentLinkedDeque/1 ConcurrentLinkedQueue/1 ConcurrentMap/2
                ConcurrentNavigableMap/2 ConcurrentSkipListMap/2 ConcurrentSkipListSet/1
                CopyOnWriteArrayList/1 CopyOnWriteArraySet/1 CountDownLatch CountedCompleter/1
                CyclicBarrier DelayQueue/1 Delayed Exchanger/1 ExecutionException Executor
                ExecutorCompletionService/1 ExecutorService Executors Flow Flow.Processor/2
                Flow.Publisher/1 Flow.Subscriber/1 Flow.Subscription ForkJoinPool
                ForkJoinPool.ForkJoinWorkerThreadFactory ForkJoinPool.ManagedBlocker ForkJoinTask/1
                ForkJoinWorkerThread Future/1 FutureTask/1 LinkedBlockingDeque/1
                LinkedBlockingQueue/1 LinkedTransferQueue/1 Phaser PriorityBlockingQueue/1
                RecursiveAction RecursiveTask/1 RejectedExecutionException RejectedExecutionHandler
                RunnableFuture/1 RunnableScheduledFuture/1 ScheduledExecutorService
                ScheduledFuture/1 ScheduledThreadPoolExecutor Semaphore SubmissionPublisher/1
                SynchronousQueue/1 ThreadFactory ThreadLocalRandom ThreadPoolExecutor
                ThreadPoolExecutor.AbortPolicy ThreadPoolExecutor.CallerRunsPolicy
                ThreadPoolExecutor.DiscardOldestPolicy ThreadPoolExecutor.DiscardPolicy TimeUnit!
                TimeoutException TransferQueue/1
            java.util.concurrent.atomic: AtomicBoolean AtomicInteger AtomicIntegerArray
                AtomicIntegerFieldUpdater/1 AtomicLong AtomicLongArray AtomicLongFieldUpdater/1
                AtomicMarkableReference/1 AtomicReference/1 AtomicReferenceArray/1
                AtomicReferenceFieldUpdater/2 AtomicStampedReference/1 DoubleAccumulator DoubleAdder
                LongAccumulator LongAdder
            java.util.function: BiConsumer/2 BiFunction/3 BiPredicate/2 BinaryOperator/1
                BooleanSupplier Consumer/1 DoubleBinaryOperator DoubleConsumer DoubleFunction/1
                DoublePredicate DoubleSupplier DoubleToIntFunction DoubleToLongFunction
                DoubleUnaryOperator Function/2 IntBinaryOperator IntConsumer IntFunction/1
                IntPredicate IntSupplier IntToDoubleFunction IntToLongFunction IntUnaryOperator
                LongBinaryOperator LongConsumer LongFunction/1 LongPredicate LongSupplier
                LongToDoubleFunction LongToIntFunction LongUnaryOperator ObjDoubleConsumer/1
                ObjIntConsumer/1 ObjLongConsumer/1 Predicate/1 Supplier/1 ToDoubleBiFunction/2
                ToDoubleFunction/1 ToIntBiFunction/2 ToIntFunction/1 ToLongBiFunction/2
                ToLongFunction/1 UnaryOperator/1
            java.util.regex: MatchResult Matcher Pattern PatternSyntaxException
            java.util.stream: BaseStream/2 Collector.Characteristics! Collector/3 Collectors
                DoubleStream DoubleStream.Builder DoubleStream.DoubleMapMultiConsumer IntStream
                IntStream.Builder IntStream.IntMapMultiConsumer LongStream LongStream.Builder
                LongStream.LongMapMultiConsumer Stream.Builder/1 Stream/1 StreamSupport
            """;

    /** The types of each package by their names there; read where somebody asks for one. */
    private static final Map<String, Lazy<Map<String, Entry>>> PACKAGES = new HashMap<>();

    static {
        // Browsers have no String.lines.
        for (int at = 0; at < TABLE.length(); ) {
            int colon = TABLE.indexOf(':', at);
            int next = TABLE.indexOf("\njava", colon) + 1;
            int end = next == 0 ? TABLE.length() : next;
            String words = TABLE.substring(colon + 1, end);
            PACKAGES.put(TABLE.substring(at, colon), new Lazy<>(() -> types(words)));
            at = end;
        }
    }

    /**
     * What is known of a type.
     *
     * @param arguments how many type arguments it takes
     * @param few whether it is an enumeration, or has no values at all
     */
    record Entry(int arguments, boolean few) {}

    private JavaLibrary() {}

    private static Map<String, Entry> types(String words) {
        Map<String, Entry> types = new HashMap<>();
        StringTokenizer each = new StringTokenizer(words);
        while (each.hasMoreTokens()) {
            String word = each.nextToken();
            boolean few = word.endsWith("!");
            String bare = few ? word.substring(0, word.length() - 1) : word;
            int slash = bare.indexOf('/');
            String name = slash < 0 ? bare : bare.substring(0, slash);
            int arguments = slash < 0 ? 0 : Integer.parseInt(bare.substring(slash + 1));
            types.put(name, new Entry(arguments, few));
        }
        return types;
    }

    /** What is known of the type of a full name, {@code java.util.Map.Entry}. */
    static Optional<Entry> find(String qualifiedName) {
        // A type may lie in another one: it is the rest behind the longest package.
        int dot = qualifiedName.lastIndexOf('.');
        while (dot >= 0) {
            String home = qualifiedName.substring(0, dot);
            Lazy<Map<String, Entry>> types = PACKAGES.get(home);
            if (types != null) {
                return Optional.ofNullable(types.get().get(qualifiedName.substring(dot + 1)));
            }
            dot = home.lastIndexOf('.');
        }
        return Optional.empty();
    }

    static boolean isPackage(String name) {
        return PACKAGES.containsKey(name);
    }
}
