<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="arcomat">
<meta name="referrer" content="no-referrer">
<title><#if address == "index.html">Arcomat: a language workbench for robots<#else>${page.title} - Arcomat</#if></title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="${root}/assets/site.css">
<script src="${root}/assets/site.js" defer></script>
</head>
<body data-root="${root}/" data-page="${address}">
<a class="skip" href="#text">To the text</a>
<header>
<a class="home" href="${root}/index.html">Arcomat</a>
<nav aria-label="Site">
<a href="${root}/docs/tutorial.html">Tutorial</a>
<a href="${root}/docs/index.html">Documentation</a>
<a href="${root}/live/index.html">Live</a>
</nav>
<form role="search" action="${root}/docs/index.html">
<label for="query">Search</label>
<input id="query" type="search" autocomplete="off" placeholder="Search the pages" aria-keyshortcuts="/" aria-controls="results">
<div id="results" hidden>
<p role="status" aria-live="polite"></p>
<ol></ol>
</div>
</form>
</header>
<div class="columns">
<details class="contents" open>
<summary>All pages</summary>
<nav aria-label="Pages">
<#list groups as group>
<h2>${group.title?cap_first}</h2>
<ul>
<#list group.entries as entry>
<li><a href="${root}/${entry.address}"<#if entry.address == address> aria-current="page"</#if>>${entry.title}</a></li>
</#list>
</ul>
</#list>
</nav>
</details>
<main id="text" tabindex="-1">
${page.body?no_esc}
<#if before?? || after??>
<nav class="order" aria-label="Before and after">
<#if before??><a rel="prev" href="${root}/${before.address}"><span>before</span> ${before.title}</a></#if>
<#if after??><a rel="next" href="${root}/${after.address}"><span>next</span> ${after.title}</a></#if>
</nav>
</#if>
</main>
<#assign sections = page.headings?filter(each -> each.level == 2)>
<aside>
<#if sections?size gt 1>
<nav aria-label="On this page">
<h2>On this page</h2>
<ul>
<#list sections as each>
<li><a href="#${each.id}">${each.text}</a></li>
</#list>
</ul>
</nav>
</#if>
</aside>
</div>
<footer>
<p>Arcomat ${version}. This page is <a href="${sourceAddress}">${source}</a> of the repository; tests run what stands on it. Nothing here counts its readers.</p>
</footer>
</body>
</html>
