"use strict";
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const root = document.documentElement;
  const dark = () => root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  document.getElementById("theme").addEventListener("click", () => { root.dataset.theme = dark() ? "light" : "dark"; });

  for (const each of document.querySelectorAll(".command")) {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = "copy";
    button.addEventListener("click", () => {
      navigator.clipboard?.writeText(each.querySelector("code").textContent);
      button.textContent = "copied";
    });
    each.append(button);
  }

  const links = new Map([...document.querySelectorAll(".bar a")].map((each) => [each.hash.slice(1), each]));
  const watch = new IntersectionObserver((entries) => {
    for (const each of entries) if (each.isIntersecting) {
      links.forEach((link) => link.classList.remove("here"));
      links.get(each.target.id)?.classList.add("here");
    }
  }, { rootMargin: "-20% 0px -70% 0px" });
  document.querySelectorAll("main > section").forEach((each) => watch.observe(each));
})();
