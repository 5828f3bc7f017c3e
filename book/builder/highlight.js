// What colours the book's code: highlight.js with the four languages of the pages, in a fifth
// of what mdBook's own copy weighs. Who adds a language runs, with this file's two packages
// (`npm install highlight.js@10.7.3 esbuild`) at hand,
//
//     esbuild book/builder/highlight.js --bundle --minify --format=iife --global-name=hljs
//         --legal-comments=inline --outfile=book/theme/highlight.js
/*! highlight.js 10.7.3: its core with rust, shell, bash and ini. BSD 3-Clause License

Copyright (c) 2006, Ivan Sagalaev.
All rights reserved.

Redistribution and use in source and binary forms, with or without
modification, are permitted provided that the following conditions are met:

* Redistributions of source code must retain the above copyright notice, this
  list of conditions and the following disclaimer.

* Redistributions in binary form must reproduce the above copyright notice,
  this list of conditions and the following disclaimer in the documentation
  and/or other materials provided with the distribution.

* Neither the name of the copyright holder nor the names of its
  contributors may be used to endorse or promote products derived from
  this software without specific prior written permission.

THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS "AS IS"
AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT LIMITED TO, THE
IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS FOR A PARTICULAR PURPOSE ARE
DISCLAIMED. IN NO EVENT SHALL THE COPYRIGHT HOLDER OR CONTRIBUTORS BE LIABLE
FOR ANY DIRECT, INDIRECT, INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL
DAMAGES (INCLUDING, BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR
SERVICES; LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER
CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT LIABILITY,
OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN ANY WAY OUT OF THE USE
OF THIS SOFTWARE, EVEN IF ADVISED OF THE POSSIBILITY OF SUCH DAMAGE. */
const hljs = require("highlight.js/lib/core");

for (const [name, language] of Object.entries({
    rust: require("highlight.js/lib/languages/rust"),
    shell: require("highlight.js/lib/languages/shell"),
    bash: require("highlight.js/lib/languages/bash"),
    ini: require("highlight.js/lib/languages/ini"),
})) hljs.registerLanguage(name, language);

hljs.highlightBlock = hljs.highlightElement; // mdBook calls it by its older name

module.exports = hljs;
